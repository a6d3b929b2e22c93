package mmneat;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.infra.BenchmarkParams;
import org.openjdk.jmh.infra.IterationParams;
import org.openjdk.jmh.profile.InternalProfiler;
import org.openjdk.jmh.results.AggregationPolicy;
import org.openjdk.jmh.results.IterationResult;
import org.openjdk.jmh.results.ScalarResult;
import org.openjdk.jmh.runner.options.TimeValue;

/**
 * A JMH profiler that reports the processor time of an operation, in the benchmark's unit, beside JMH's elapsed time.
 *
 * <p>Elapsed time includes the time in which the benchmark waits for a processor. On a shared machine it can be several
 * times the processor time. The processor time is that of all threads of the process, garbage collection and
 * compilation included.
 */
public final class ProcessorTime implements InternalProfiler {

    private final OperatingSystemMXBean system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    private long start;

    @Override
    public String getDescription() {
        return "Processor time per operation";
    }

    @Override
    public void beforeIteration(BenchmarkParams benchmark, IterationParams iteration) {
        start = system.getProcessCpuTime();
    }

    @Override
    public Collection<ScalarResult> afterIteration(
            BenchmarkParams benchmark, IterationParams iteration, IterationResult result) {
        long time = system.getProcessCpuTime() - start;
        TimeUnit unit = benchmark.getTimeUnit();
        double perOperation =
                (double) time / unit.toNanos(1) / result.getMetadata().getAllOps();
        return List.of(new ScalarResult(
                "processorTime", perOperation, TimeValue.tuToString(unit) + "/op", AggregationPolicy.AVG));
    }
}
