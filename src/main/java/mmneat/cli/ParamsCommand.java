package mmneat.cli;

import java.io.PrintWriter;
import java.util.concurrent.Callable;
import mmneat.experiment.parameters.Parameter;
import mmneat.experiment.parameters.ParameterCatalogue;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Parameters;

/** The command {@code params}: lists the parameters, or describes one. */
@Command(
        name = "params",
        customSynopsis = "mmneat params [NAME|all]",
        description = {
            "Lists the parameters of experiments, or describes one.",
            "",
            "Example: mmneat params crossoverRate",
            "",
        })
final class ParamsCommand extends ConsoleCommand implements Callable<Integer> {

    @Parameters(
            arity = "0..1",
            paramLabel = "NAME",
            description = "Name of a parameter; all lists the parameters that are not supported, too.")
    private String name = "";

    @Override
    public Integer call() {
        ParameterCatalogue catalogue = ParameterCatalogue.load();
        PrintWriter out = out();
        if (name.isEmpty() || name.equals("all")) {
            list(out, catalogue);
        } else {
            describe(out, catalogue.require(name));
        }
        out.flush();
        return ExitCode.OK;
    }

    private void list(PrintWriter out, ParameterCatalogue catalogue) {
        String group = "";
        int hidden = 0;
        for (Parameter parameter : catalogue.all()) {
            if (parameter.support() != Parameter.Support.YES && !name.equals("all")) {
                hidden++;
                continue;
            }
            if (!parameter.group().equals(group)) {
                group = parameter.group();
                out.println((parameter.isOfOriginal() ? "\n" : "") + group);
            }
            out.printf(
                    "  %-32s %-8s %s%s%n",
                    parameter.name() + "=" + parameter.defaultValue(),
                    parameter.type(),
                    parameter.meaning(),
                    parameter.support() == Parameter.Support.NO ? " (not supported)" : "");
        }
        if (hidden > 0) {
            out.println("\n" + hidden
                    + " parameters of the original have no effect or are not supported; 'params all' lists"
                    + " them too. The value after = is the default. The paper's tasks set other values; see configs.");
        }
    }

    private static void describe(PrintWriter out, Parameter parameter) {
        out.println(parameter.name() + " (" + parameter.group() + ")");
        out.println("  " + parameter.meaning() + ".");
        out.println("  type      " + parameter.type());
        out.println("  allowed   " + parameter.allowedInWords());
        out.println("  default   " + (parameter.defaultValue().isEmpty() ? "(none)" : parameter.defaultValue()));
        out.println("  support   "
                + switch (parameter.support()) {
                    case YES -> "yes";
                    case IGNORED -> "accepted, without effect";
                    case NO -> "no: any other value than the default is an error";
                });
    }
}
