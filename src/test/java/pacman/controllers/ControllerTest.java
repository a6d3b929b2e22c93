package pacman.controllers;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** Threads of a controller in timed games: docs/specification/controllers.md, section 2. */
@Timeout(60)
class ControllerTest {

    /** A controller that reports each decision and ends it when the test allows it. */
    private static final class Slow extends Controller<MOVE> {
        final BlockingQueue<Game> asked = new LinkedBlockingQueue<>();
        final Semaphore allowed = new Semaphore(0);
        volatile MOVE answer = MOVE.UP;
        volatile Thread worker;

        @Override
        public MOVE getMove(Game game, long timeDue) {
            worker = Thread.currentThread();
            asked.add(game);
            allowed.acquireUninterruptibly();
            if (answer == null) {
                throw new IllegalStateException("no idea");
            }
            return answer;
        }
    }

    private final Slow controller = new Slow();
    private final Game first = new Game(1);
    private final Game second = new Game(2);
    private final Game third = new Game(3);
    private Thread supervisor;

    @AfterEach
    void end() {
        controller.terminate();
        controller.allowed.release(100);
    }

    private void start() {
        supervisor = new Thread(controller);
        supervisor.start();
    }

    private Game nextAsked() throws InterruptedException {
        return controller.asked.poll(30, TimeUnit.SECONDS);
    }

    private void awaitComputed() {
        while (!controller.hasComputed()) {
            Thread.onSpinWait();
        }
    }

    /** Waits until the supervisor has handled all updates; a later update would be left to the next worker. */
    private void awaitWaitingSupervisor() {
        while (supervisor.getState() != Thread.State.WAITING) {
            Thread.onSpinWait();
        }
    }

    @Test
    void answer_isStoredWhenTheDecisionEnds() throws InterruptedException {
        start();
        assertThat(controller.getMove()).isNull();
        controller.update(first, 0);
        assertThat(nextAsked()).isSameAs(first);
        assertThat(controller.hasComputed()).isFalse();
        controller.allowed.release();
        awaitComputed();
        assertThat(controller.getMove()).isEqualTo(MOVE.UP);
    }

    @Test
    void updatesWhileBusy_areNotCaughtUp() throws InterruptedException {
        start();
        controller.update(first, 0);
        assertThat(nextAsked()).isSameAs(first);
        controller.update(second, 0);
        controller.update(third, 0);
        awaitWaitingSupervisor();
        controller.allowed.release();
        // A late decision counts as an answer, even if newer states have been supplied.
        awaitComputed();
        assertThat(controller.asked).isEmpty();
        Game fourth = new Game(4);
        controller.update(fourth, 0);
        assertThat(nextAsked()).isSameAs(fourth);
    }

    @Test
    void directCall_storesNothing() {
        controller.allowed.release();
        assertThat(controller.getMove(first, 0)).isEqualTo(MOVE.UP);
        assertThat(controller.getMove()).isNull();
    }

    @Test
    void exception_freezesTheControllerOnItsAnswer_andNamesIt_untilItIsRevived() throws InterruptedException {
        BlockingQueue<String> failedThreads = new LinkedBlockingQueue<>();
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> failedThreads.add(thread.getName()));
        try {
            start();
            controller.update(first, 0);
            controller.allowed.release();
            awaitComputed();
            controller.answer = null;
            controller.update(second, 0);
            controller.allowed.release();
            assertThat(failedThreads.poll(30, TimeUnit.SECONDS)).isEqualTo("controller " + Slow.class.getName());
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
        controller.asked.clear();
        controller.update(third, 0);
        controller.terminate();
        supervisor.join();
        assertThat(controller.asked).isEmpty();
        assertThat(controller.hasComputed()).isFalse();
        assertThat(controller.getMove()).isEqualTo(MOVE.UP);

        controller.threadRevive();
        controller.answer = MOVE.DOWN;
        start();
        controller.update(third, 0);
        controller.allowed.release();
        awaitComputed();
        assertThat(controller.getMove()).isEqualTo(MOVE.DOWN);
    }

    @Test
    void termination_makesAnIdleControllerDecideOnceMore() throws InterruptedException {
        start();
        controller.update(first, 0);
        controller.allowed.release();
        awaitComputed();
        assertThat(nextAsked()).isSameAs(first);
        // The worker lowers its busy flag right after it has stored its answer, together with it.
        controller.terminate();
        supervisor.join();
        assertThat(nextAsked()).isSameAs(first);
    }

    @Test
    void controllerThatIsTerminatedBeforeItsFirstGame_decidesNothing() throws InterruptedException {
        ThreadGroup group = new ThreadGroup("supervisor and workers");
        supervisor = new Thread(group, controller, "supervisor");
        supervisor.start();
        awaitWaitingSupervisor();
        controller.terminate();
        while (group.activeCount() > 0) {
            Thread.onSpinWait();
        }
        assertThat(controller.decisions().failure()).isNull();
        assertThat(controller.asked).isEmpty();
        controller.threadRevive();
        start();
        controller.update(first, 0);
        assertThat(nextAsked()).isSameAs(first);
    }

    @Test
    void terminatedController_decidesNothing_untilItIsRevived() throws InterruptedException {
        controller.terminate();
        start();
        supervisor.join();
        controller.update(first, 0);
        assertThat(controller.asked).isEmpty();
        controller.threadRevive();
        start();
        controller.update(second, 0);
        assertThat(nextAsked()).isSameAs(second);
    }

    /** A controller that answers immediately. */
    private static final class Quick extends Controller<MOVE> {
        @Override
        public MOVE getMove(Game game, long timeDue) {
            return MOVE.UP;
        }
    }

    @Test
    void revivedController_alwaysDecidesAgain_whateverTheLastDecisionOfTheGameBeforeDoes() throws InterruptedException {
        Quick quick = new Quick();
        for (int cycle = 0; cycle < 1000; cycle++) {
            Thread game = new Thread(quick);
            game.start();
            // A worker of the previous game may still be deciding at the first update: then the next update counts.
            while (!quick.hasComputed()) {
                quick.update(first, 0);
                for (int look = 0; look < 100 && !quick.hasComputed(); look++) {
                    Thread.onSpinWait();
                }
            }
            quick.terminate();
            game.join();
            quick.threadRevive();
        }
    }

    @Test
    void supervisorThatSleepsThroughEndAndRevival_servesNoLaterGame() throws InterruptedException {
        start();
        awaitWaitingSupervisor();
        Thread sleeper = supervisor;
        synchronized (controller) {
            // The sleeping supervisor cannot check before the lock is free.
            controller.terminate();
            controller.threadRevive();
        }
        sleeper.join();
        start();
        controller.update(second, 0);
        assertThat(nextAsked()).isSameAs(second);
        controller.allowed.release();
        awaitComputed();
        assertThat(controller.asked).isEmpty();
    }

    @Test
    void leftOverDecision_doesNotAnswerInTheNextGame() throws InterruptedException {
        start();
        controller.update(first, 0);
        nextAsked();
        controller.terminate();
        supervisor.join();
        controller.threadRevive();
        Thread worker = controller.worker;
        controller.allowed.release();
        worker.join();
        assertThat(controller.getMove()).isNull();
        assertThat(controller.hasComputed()).isFalse();
    }

    /** A controller that records how many threads decide at the same time. */
    private static final class Crowded extends Controller<MOVE> {
        private final AtomicInteger inside = new AtomicInteger();
        private volatile boolean wasCrowded;

        @Override
        public MOVE getMove(Game game, long timeDue) {
            wasCrowded |= inside.incrementAndGet() > 1;
            Thread.yield();
            inside.decrementAndGet();
            return MOVE.UP;
        }
    }

    @Test
    void decisions_neverOverlap_howeverFastTheUpdatesCome_andAcrossRevivals() throws InterruptedException {
        Crowded crowded = new Crowded();
        for (int game = 0; game < 50; game++) {
            Thread running = new Thread(crowded);
            running.start();
            for (int update = 0; update < 100; update++) {
                crowded.update(first, 0);
                Thread.yield();
            }
            crowded.terminate();
            running.join();
            crowded.threadRevive();
        }
        assertThat(crowded.wasCrowded).isFalse();
    }

    @Test
    void leftOverDecision_isWaitedForInTheNextGame() throws InterruptedException {
        start();
        controller.update(first, 0);
        assertThat(nextAsked()).isSameAs(first);
        controller.terminate();
        supervisor.join();
        controller.threadRevive();
        start();
        controller.update(second, 0);
        awaitWaitingSupervisor();
        assertThat(controller.asked).as("the first decision has not ended").isEmpty();
        controller.allowed.release(2);
        assertThat(nextAsked()).isSameAs(second);
        awaitComputed();
        assertThat(Decisions.of(controller)).isEqualTo(new Decisions(1, 1, true, null));
    }
}
