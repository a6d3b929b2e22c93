package mmneat.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import mmneat.cli.options.ArgumentSyntax;
import mmneat.cli.options.Range;
import mmneat.cli.output.OutputFile;
import mmneat.experiment.ExitGuard;
import mmneat.experiment.UserError;
import mmneat.experiment.cluster.CommandList;
import mmneat.experiment.cluster.CondorSubmitFile;
import mmneat.experiment.cluster.ExperimentJob;
import mmneat.experiment.cluster.JobResources;
import mmneat.experiment.cluster.KubernetesManifest;
import mmneat.experiment.cluster.ShellWord;
import mmneat.experiment.cluster.SlurmScript;
import mmneat.experiment.cluster.SlurmSubmission;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.run.ExperimentView;
import mmneat.experiment.run.Study;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The command {@code submit}: submits the unfinished runs of experiments to a scheduler, one job per run. */
@Command(
        name = "submit",
        customSynopsis =
                "mmneat submit task=TASK[,TASK...] [method=METHOD[,METHOD...]|all] [runs=N] [engine=...] [name=value...]",
        description = {
            "Submits the unfinished runs of experiments to a scheduler.",
            "",
            "Each run becomes one job. All words that are not options are parameters of the experiments; "
                    + "see params. Lists of tasks and methods make several experiments.",
            "",
            "Example: mmneat submit runs=30 task=blended,isolated method=1M,2M engine=slurm time=12:00:00",
            "Example: mmneat submit runs=30 task=blended method=all engine=parallel | parallel -j 16",
            "",
        })
final class SubmitCommand extends ConsoleCommand implements Callable<Integer> {

    private static final String LOCAL = "local";

    /** Options of sbatch that are passed on with the same names. */
    private static final List<String> SLURM_OPTIONS = List.of("partition", "account", "qos", "constraint");

    private static final class Engines extends ArrayList<String> {
        Engines() {
            super(List.of(LOCAL, "slurm", "htcondor", "kubernetes", "parallel"));
        }
    }

    @Parameters(
            arity = "0..*",
            paramLabel = ArgumentSyntax.PARAMETER,
            description = "Parameters of the experiments; see params.")
    private List<String> parameters = new ArrayList<>();

    @Option(
            names = "engine",
            paramLabel = "ENGINE",
            defaultValue = LOCAL,
            completionCandidates = Engines.class,
            description = "Scheduler that starts the jobs: ${COMPLETION-CANDIDATES}; local runs them here at once"
                    + " (default: ${DEFAULT-VALUE}).")
    private String engine;

    @Option(
            names = "cpus",
            paramLabel = "N",
            defaultValue = "1",
            description = "Processors per run; a run uses one unless parallelEvaluations=true"
                    + " (default: ${DEFAULT-VALUE}).")
    @Range(min = 1, max = 1024)
    private int cpus;

    /** The measured peak of a run of mu=100 is well below the default; see docs/performance.md. */
    @Option(
            names = "memory",
            paramLabel = "SIZE",
            defaultValue = "1G",
            description = "Memory per run (default: ${DEFAULT-VALUE}).")
    private String memory;

    @Option(
            names = "time",
            paramLabel = "H:MM:SS",
            defaultValue = "12:00:00",
            description = "Maximum time of a job; the run then saves and is queued again (default: ${DEFAULT-VALUE}).")
    private String time;

    @Option(names = "partition", paramLabel = "NAME", description = "Slurm: the partition.")
    private @Nullable String partition;

    @Option(names = "account", paramLabel = "NAME", description = "Slurm: the account.")
    private @Nullable String account;

    @Option(names = "qos", paramLabel = "NAME", description = "Slurm: the quality of service.")
    private @Nullable String qos;

    @Option(names = "constraint", paramLabel = "TEXT", description = "Slurm: features that the machines must have.")
    private @Nullable String constraint;

    @Option(
            names = "image",
            paramLabel = "IMAGE",
            defaultValue = "eclipse-temurin:17-jre",
            description = "Kubernetes: container image with Java (default: ${DEFAULT-VALUE}).")
    private String image;

    @Option(
            names = "claim",
            paramLabel = "NAME",
            defaultValue = "mmneat",
            description = "Kubernetes: persistent volume claim of the working folder (default: ${DEFAULT-VALUE}).")
    private String claim;

    @Option(
            names = "java",
            paramLabel = "PROGRAM",
            description = "Java command on the machines that run the jobs (default: ${DEFAULT-VALUE}).")
    private String java = "java";

    @Option(
            names = "dryRun",
            paramLabel = "true|false",
            arity = "1",
            defaultValue = "false",
            description = "Slurm: writes the scripts and shows what would be submitted (default: ${DEFAULT-VALUE}).")
    private boolean dryRun;

    @Override
    public Integer call() throws Exception {
        requireEffects();
        Study study = ExitGuard.guard(notes(), () -> Study.of(parameters, ParameterCatalogue.load()));
        PrintWriter errors = notes();
        study.remarks().forEach(remark -> errors.println("mmneat: " + remark));
        errors.flush();
        return engine.equals(LOCAL) ? runHere(study) : handOver(study);
    }

    private void requireEffects() {
        for (String name : List.of("cpus", "memory", "time", "java")) {
            requireEffect(name, !engine.equals(LOCAL), "engine=local does not use it");
        }
        for (String name : List.of("image", "claim")) {
            requireEffect(name, engine.equals("kubernetes"), "it is for engine=kubernetes");
        }
        requireEffect("dryRun", engine.equals("slurm"), "only engine=slurm submits by itself");
        SLURM_OPTIONS.forEach(name -> requireEffect(name, engine.equals("slurm"), "it is for engine=slurm"));
    }

    /** Runs the experiments on this machine, one after the other, like the main job. */
    private int runHere(Study study) throws InterruptedException, IOException {
        int worst = ExitCode.OK;
        for (Study.Part part : study.parts()) {
            PrintWriter out = out();
            worst = MainJob.worse(worst, new MainJob(part.words(), out, notes()).call());
            if (!part.plan().parameters().flag("quiet")) {
                out.println();
                out.flush();
            }
        }
        return worst;
    }

    private int handOver(Study study) throws IOException {
        JobResources resources =
                new JobResources(cpus, JobResources.parseMemory(memory), JobResources.parseTime(time), java);
        PrintWriter out = out();
        Path jar = ownJar();
        List<String> submitted = new ArrayList<>();
        for (Study.Part part : study.parts()) {
            List<Integer> runs = part.unfinishedRuns();
            int all = part.plan().runs().size();
            if (runs.isEmpty()) {
                note(out, part.plan().name() + ": all " + all + " runs are complete");
                continue;
            }
            if (all > 1) {
                // Runs that were not started are then shown as waiting; the jobs themselves write only into their own
                // folders.
                ExperimentView.recordRequested(part.plan());
            }
            ExperimentJob job = new ExperimentJob(
                    part.plan().name(),
                    part.plan().base(),
                    Path.of("").toAbsolutePath(),
                    jar,
                    part.words().stream()
                            .filter(word -> !word.matches("(runs?|runNumber)[=:].*"))
                            .toList(),
                    runs);
            note(out, job.name() + ": " + runs.size() + " of " + all + " runs to do");
            switch (engine) {
                case "slurm" -> submitted.addAll(slurm(job, resources, out));
                case "htcondor" -> {
                    Path file = write(job.file("condor"), CondorSubmitFile.of(job, resources));
                    out.println("  wrote " + file + "; submit it with: "
                            + ShellWord.line(List.of("condor_submit", file.toString())));
                }
                case "kubernetes" -> {
                    String manifest = KubernetesManifest.of(job, resources, image, claim);
                    Path file = write(job.file("yaml"), manifest);
                    out.println("  wrote " + file + "; submit it with: "
                            + ShellWord.line(List.of("kubectl", "apply", "-f", file.toString())));
                }
                default -> CommandList.of(job, resources).forEach(out::println);
            }
        }
        if (!submitted.isEmpty()) {
            out.println("Follow the jobs with: squeue --job " + String.join(",", submitted));
            out.println("Follow the runs with: "
                    + ShellCommand.command(
                            "status", study.parts().get(0).plan().base().toString()));
        }
        out.flush();
        return ExitCode.OK;
    }

    private List<String> slurm(ExperimentJob job, JobResources resources, PrintWriter out) throws IOException {
        Map<String, String> options = new LinkedHashMap<>();
        put(options, "partition", partition);
        put(options, "account", account);
        put(options, "qos", qos);
        put(options, "constraint", constraint);
        Path script = write(job.file("slurm"), SlurmScript.of(job, resources, options));
        out.println("  wrote " + script);
        if (dryRun) {
            SlurmScript.submitCommands(job, Integer.MAX_VALUE)
                    .forEach(line -> out.println("  would submit: " + ShellWord.line(line)));
            return List.of();
        }
        List<String> ids = SlurmSubmission.submit(job, SlurmSubmission.arrayLimit());
        out.println("  submitted as job " + String.join(", ", ids));
        return ids;
    }

    private static void put(Map<String, String> options, String name, @Nullable String value) {
        if (value != null) {
            options.put(name, value);
        }
    }

    /** Prints a message; to standard error if standard output contains a list of commands for other programs. */
    private void note(PrintWriter out, String line) {
        PrintWriter target = engine.equals("parallel") ? notes() : out;
        target.println(line);
        target.flush();
    }

    private static Path write(Path file, String text) {
        OutputFile.write(file, text);
        return file;
    }

    /** Returns the jar of this program, which the jobs also use. */
    private static Path ownJar() {
        try {
            Path place = Path.of(SubmitCommand.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
            if (!Files.isRegularFile(place)) {
                throw new UserError("submit needs the packaged jar: build it with mvn package, then run java -jar"
                        + " target/mmneat.jar submit ...");
            }
            return place.toAbsolutePath();
        } catch (URISyntaxException e) {
            throw new IllegalStateException("a class was loaded from a place that is not a file", e);
        }
    }
}
