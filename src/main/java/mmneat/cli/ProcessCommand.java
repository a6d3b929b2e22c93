package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import mmneat.cli.options.ArgumentSyntax;
import mmneat.experiment.UserError;
import mmneat.experiment.original.RunSummaries;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.Tasks;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.experiment.run.RunPlan;
import mmneat.experiment.store.RunLayout;
import mmneat.experiment.store.RunParametersFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/**
 * The command {@code process}: writes the summaries over the runs of an experiment that the original writes if its
 * first argument is {@code process}. They are averaged logs, hypervolumes and gnuplot scripts ({@link RunSummaries}),
 * for existing scripts that read such files.
 */
@Command(
        name = "process",
        customSynopsis = "mmneat process NAME=VALUE...",
        description = {
            "Writes the original's summaries over the runs of an experiment.",
            "",
            "Writes hypervolumes, logs averaged over the runs, and gnuplot scripts for them, beside the "
                    + "folders of the runs. Give the parameters with which the runs were made; others are remarked. "
                    + "Runs that have not begun are left out.",
            "",
            "Example: mmneat process task=blended method=2M runs=30",
            "",
        })
final class ProcessCommand extends ConsoleCommand implements Runnable {

    @Parameters(
            arity = "0..*",
            paramLabel = ArgumentSyntax.PARAMETER,
            description = "The parameters of the experiment; see params.")
    private List<String> words = new ArrayList<>();

    @Override
    public void run() {
        ParameterReader.Result read = new ParameterReader(ParameterCatalogue.load()).read(words);
        ExperimentPlan plan = ExperimentPlan.of(read.parameters());
        List<Integer> begun = plan.runs().stream()
                .filter(ProcessCommand::hasBegun)
                .map(RunPlan::number)
                .toList();
        if (begun.isEmpty()) {
            throw new UserError(
                    plan.runs().get(0).directory()
                            + ": no run has the logs of a complete generation (io=false writes none); give the parameters that the runs were made with");
        }
        String saveTo = plan.parameters().text("saveTo");
        new RunSummaries(
                        plan.base(),
                        saveTo,
                        plan.name(),
                        Tasks.factory(plan.parameters()).get())
                .write(begun);
        remarkOnParameters(plan);
        PrintWriter out = out();
        out.println(begun.size() + " of " + plan.runs().size() + " runs summarised in "
                + plan.base().resolve(RunLayout.log(plan.name() + "AVG_", RunLayout.PARENTS)) + " and beside it");
        out.flush();
    }

    /** Says which runs were made with other parameters than those given. Runs of the original have no file of them. */
    private void remarkOnParameters(ExperimentPlan plan) {
        Map<String, List<String>> runs = new LinkedHashMap<>();
        for (RunPlan run : plan.runs()) {
            RunParametersFile file = new RunParametersFile(run.directory());
            if (hasBegun(run) && file.exists()) {
                runs.computeIfAbsent(String.join(", ", file.differences(run.parameters())), unused -> new ArrayList<>())
                        .add(String.valueOf(run.number()));
            }
        }
        runs.remove("");
        runs.forEach((differences, numbers) -> notes().println("mmneat: run(s) " + String.join(", ", numbers)
                + " begun with " + differences + "; the summaries are of the runs as they are"));
        notes().flush();
    }

    private static boolean hasBegun(RunPlan run) {
        return Files.exists(run.directory().resolve(RunLayout.log(run.prefix(), RunLayout.CHILDREN)));
    }
}
