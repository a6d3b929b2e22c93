package mmneat.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
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
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;

/** Hands the unfinished runs of experiments to a scheduler, one job per run. */
@Command(
        name = "submit",
        customSynopsis =
                "mmneat submit task=TASK[,TASK...] [method=METHOD[,METHOD...]|all] [runs=N] [engine=...] [name=value...]",
        description = {
            "Hands the unfinished runs of experiments to a scheduler, one job per run. Every other word is a parameter"
                    + " of the experiments; see params.",
            "",
            "Example: mmneat submit runs=30 task=blended,isolated method=1M,2M engine=slurm time=12:00:00",
            "Example: mmneat submit runs=30 task=blended method=all engine=parallel | parallel -j 16",
            "",
        })
final class SubmitCommand extends WordCommand implements Callable<Integer> {

    /** The measured peak of a run of mu=100 is well below; see docs/performance.md. */
    private static final String DEFAULT_MEMORY = "1G";

    private static final String DEFAULT_TIME = "12:00:00";

    /** Options of sbatch that are passed on under their own names. */
    private static final List<String> SLURM_OPTIONS = List.of("partition", "account", "qos", "constraint");

    private static final List<String> ENGINES = List.of("local", "slurm", "htcondor", "kubernetes", "parallel");

    @Override
    List<Word> knownWords() {
        return List.of(
                new Word("engine", String.join("|", ENGINES), "who places the jobs (default local: this machine, now)"),
                new Word("cpus", "N", "processors per run (default 1: a run uses one unless parallelEvaluations=true)"),
                new Word("memory", "1G", "memory per run (default " + DEFAULT_MEMORY + ")"),
                new Word(
                        "time",
                        "H:MM:SS",
                        "longest time of a job; the run then saves and is queued again (default " + DEFAULT_TIME + ")"),
                new Word("partition", "NAME", "slurm: partition; account=, qos= and constraint= likewise"),
                new Word("account", "NAME", "slurm: account"),
                new Word("qos", "NAME", "slurm: quality of service"),
                new Word("constraint", "TEXT", "slurm: features that the machines must have"),
                new Word("image", "IMAGE", "kubernetes: container image with Java (default eclipse-temurin:17-jre)"),
                new Word(
                        "claim",
                        "NAME",
                        "kubernetes: persistent volume claim with the working folder (default mmneat)"),
                new Word("java", "PROGRAM", "Java of the machines that run the jobs (default java)"),
                new Word("dryRun", "true", "slurm: writes the scripts and shows what would be submitted"));
    }

    @Override
    public Integer call() throws Exception {
        List<String> names = knownWords().stream().map(Word::name).toList();
        Map<Boolean, List<String>> split = arguments().stream()
                .collect(Collectors.partitioningBy(word -> names.contains(word.split("[=:]", 2)[0])));
        Words own = Words.parse(split.get(true), names);
        String engine = own.choice("engine", "local", ENGINES);
        requireEffects(own, engine);
        Study study = Study.of(split.get(false), ParameterCatalogue.load());
        PrintWriter errors = notes();
        study.remarks().forEach(remark -> errors.println("mmneat: " + remark));
        errors.flush();
        return engine.equals("local") ? runHere(study) : handOver(study, engine, own);
    }

    private static void requireEffects(Words own, String engine) {
        for (String name : List.of("cpus", "memory", "time", "java")) {
            own.requireEffect(name, !engine.equals("local"), "engine=local asks nobody for it");
        }
        for (String name : List.of("image", "claim")) {
            own.requireEffect(name, engine.equals("kubernetes"), "it is for engine=kubernetes");
        }
        own.requireEffect("dryRun", engine.equals("slurm"), "only engine=slurm submits by itself");
        SLURM_OPTIONS.forEach(name -> own.requireEffect(name, engine.equals("slurm"), "it is for engine=slurm"));
    }

    /** The present behaviour of the main job, one experiment after the other. */
    private int runHere(Study study) throws InterruptedException, IOException {
        int worst = ExitCode.OK;
        for (Study.Part part : study.parts()) {
            PrintWriter out = out();
            worst = Math.max(worst, new MainJob(part.words(), out, notes()).call());
            if (!part.plan().parameters().flag("quiet")) {
                out.println();
                out.flush();
            }
        }
        return worst;
    }

    private int handOver(Study study, String engine, Words own) throws IOException {
        JobResources resources = new JobResources(
                own.integer("cpus", 1, 1, 1024),
                JobResources.parseMemory(own.text("memory", DEFAULT_MEMORY)),
                JobResources.parseTime(own.text("time", DEFAULT_TIME)),
                own.text("java", "java"));
        PrintWriter out = out();
        Path jar = ownJar();
        List<String> submitted = new ArrayList<>();
        for (Study.Part part : study.parts()) {
            List<Integer> runs = part.unfinishedRuns();
            int all = part.plan().runs().size();
            if (runs.isEmpty()) {
                tell(engine, out, part.plan().name() + ": all " + all + " runs are complete");
                continue;
            }
            if (all > 1) {
                // Runs that have not begun are then seen as waiting; the jobs themselves write only into their own
                // folders.
                ExperimentView.recordAsked(part.plan());
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
            tell(engine, out, job.name() + ": " + runs.size() + " of " + all + " runs to do");
            switch (engine) {
                case "slurm" -> submitted.addAll(slurm(job, resources, own, out));
                case "htcondor" -> {
                    Path file = write(job.file("condor"), CondorSubmitFile.of(job, resources));
                    out.println("  wrote " + file + "; submit it with: "
                            + ShellWord.line(List.of("condor_submit", file.toString())));
                }
                case "kubernetes" -> {
                    String manifest = KubernetesManifest.of(
                            job, resources, own.text("image", "eclipse-temurin:17-jre"), own.text("claim", "mmneat"));
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
                    + ThisProgram.command(
                            "status", study.parts().get(0).plan().base().toString()));
        }
        out.flush();
        return ExitCode.OK;
    }

    private List<String> slurm(ExperimentJob job, JobResources resources, Words own, PrintWriter out)
            throws IOException {
        Map<String, String> options = new LinkedHashMap<>();
        SLURM_OPTIONS.forEach(name -> own.text(name).ifPresent(value -> options.put(name, value)));
        Path script = write(job.file("slurm"), SlurmScript.of(job, resources, options));
        out.println("  wrote " + script);
        if (own.flag("dryRun", false)) {
            SlurmScript.submitCommands(job, Integer.MAX_VALUE)
                    .forEach(line -> out.println("  would submit: " + ShellWord.line(line)));
            return List.of();
        }
        List<String> ids = SlurmSubmission.submit(job, SlurmSubmission.arrayLimit());
        out.println("  submitted as job " + String.join(", ", ids));
        return ids;
    }

    /** Beside a list of commands, which other programs read from standard output, words go to standard error. */
    private void tell(String engine, PrintWriter out, String line) {
        PrintWriter target = engine.equals("parallel") ? notes() : out;
        target.println(line);
        target.flush();
    }

    private static Path write(Path file, String text) throws IOException {
        if (file.getParent() != null) {
            Files.createDirectories(file.getParent());
        }
        return Files.writeString(file, text, StandardCharsets.UTF_8);
    }

    /** The jar that this program runs from: the jobs run the same. */
    private static Path ownJar() {
        try {
            Path place = Path.of(SubmitCommand.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
            if (!Files.isRegularFile(place)) {
                throw new UserError("submit needs the packaged jar: build it with mvn package, then java -jar"
                        + " target/mmneat.jar submit ...");
            }
            return place.toAbsolutePath();
        } catch (URISyntaxException e) {
            throw new IllegalStateException("a class was loaded from a place that is no file", e);
        }
    }
}
