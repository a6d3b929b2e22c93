package tour;

import java.awt.Color;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Vector;
import javax.swing.JPanel;
import pacman.Executor;
import pacman.controllers.Controller;
import pacman.controllers.HumanController;
import pacman.controllers.KeyBoardInput;
import pacman.controllers.NewGhostController;
import pacman.controllers.NewPacManController;
import pacman.controllers.examples.AggressiveGhosts;
import pacman.controllers.examples.BetterLegacy;
import pacman.controllers.examples.ChaseFleeGhosts;
import pacman.controllers.examples.DeterministicLegacy;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.Legacy2TheReckoning;
import pacman.controllers.examples.NearestPillPacMan;
import pacman.controllers.examples.NearestPillPacManVS;
import pacman.controllers.examples.PansyGhosts;
import pacman.controllers.examples.RandomGhosts;
import pacman.controllers.examples.RandomNonRevPacMan;
import pacman.controllers.examples.RandomPacMan;
import pacman.controllers.examples.StarterGhosts;
import pacman.controllers.examples.StarterPacMan;
import pacman.controllers.examples.VeryRandomLegacy;
import pacman.entries.ghosts.MyGhosts;
import pacman.entries.pacman.MyPacMan;
import pacman.game.Constants;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameView;
import pacman.game.util.IO;
import pacman.game.util.Log;

/** A program around entries: runs every mode, view and file that the interface has; needs the simulator's jar alone. */
public class Tour {

    /** Ends a game at once by MM-NEAT's rules; by the competition's it lets her stand. */
    static class Still extends NewPacManController {
        public int getAction(Game game, long timeDue) {
            return NewPacManController.END_GAME_CODE;
        }

        public void logEvaluationDetails() {}
    }

    static class Nobody extends NewGhostController {
        public EnumMap<GHOST, MOVE> getMove(Game game, long timeDue) {
            return null;
        }
    }

    public static void main(String[] arguments) throws Exception {
        System.setProperty("java.awt.headless", "true");
        files();
        examples();
        view();
        executor();
        controllerThreads();
        if (arguments.length > 0) {
            unending();
        }
        System.out.println("toured");
    }

    private static void examples() {
        List<Controller<MOVE>> players = new ArrayList<Controller<MOVE>>();
        players.add(new StarterPacMan());
        players.add(new NearestPillPacMan());
        players.add(new NearestPillPacManVS());
        players.add(new RandomPacMan());
        players.add(new RandomNonRevPacMan());
        players.add(new MyPacMan());
        players.add(new HumanController(new KeyBoardInput()));
        players.add(new TouringPacMan());
        List<Controller<EnumMap<GHOST, MOVE>>> teams = new ArrayList<Controller<EnumMap<GHOST, MOVE>>>();
        teams.add(new Legacy());
        teams.add(new AggressiveGhosts());
        teams.add(new BetterLegacy());
        teams.add(new ChaseFleeGhosts());
        teams.add(new DeterministicLegacy());
        teams.add(new Legacy2TheReckoning());
        teams.add(new PansyGhosts());
        teams.add(new RandomGhosts());
        teams.add(new StarterGhosts());
        teams.add(new VeryRandomLegacy());
        teams.add(new MyGhosts());
        teams.add(new TouringGhosts());
        Game game = new Game(1);
        for (Controller<MOVE> player : players) {
            player.getMove(game.copy(), -1);
        }
        for (Controller<EnumMap<GHOST, MOVE>> team : teams) {
            team.getMove(game.copy(), -1);
        }
        // The types that the interface lists for the examples.
        EnumMap<GHOST, MOVE> moves = new Legacy().getMove(game, -1);
        moves = new AggressiveGhosts().getMove(game, -1);
        moves = new BetterLegacy().getMove(game, -1);
        moves = new ChaseFleeGhosts().getMove(game, -1);
        moves = new DeterministicLegacy().getMove(game, -1);
        moves = new Legacy2TheReckoning().getMove(game, -1);
        moves = new PansyGhosts().getMove(game, -1);
        moves = new RandomGhosts().getMove(game, -1);
        moves = new StarterGhosts().getMove(game, -1);
        moves = new VeryRandomLegacy().getMove(game, -1);
        moves = new MyGhosts().getMove(game, -1);
        MOVE move = new StarterPacMan().getMove(game, -1);
        move = new NearestPillPacMan().getMove(game, -1);
        move = new NearestPillPacManVS().getMove(game, -1);
        move = new RandomPacMan().getMove(game, -1);
        move = new RandomNonRevPacMan().getMove(game, -1);
        move = new MyPacMan().getMove(game, -1);
        int distances =
                Legacy2TheReckoning.CROWDED_DISTANCE + Legacy2TheReckoning.PACMAN_DISTANCE + Legacy2TheReckoning.PILL_PROXIMITY;
        NewPacManController still = new Still();
        still.reset();
        still.logEvaluationDetails();
        still.getMove(game, still.getAction(game, -1) + distances);
        NewGhostController nobody = new Nobody();
        nobody.reset();
    }

    private static void view() {
        Game game = new Game(0);
        GameView view = new GameView(game).showGame();
        GameView.addPoints(game, Color.RED, 1, 2, 3);
        GameView.addLines(game, Color.RED, 1, 2);
        GameView.addLines(game, Color.RED, new int[] {1}, new int[] {2});
        GameView.debugPointers = new Vector<>(GameView.debugPointers);
        GameView.debugLines = new Vector<>(GameView.debugLines);
        Constants.pathImages = "images";
        Constants.mazeNames = new String[] {"a.png"};
        GameView.saveImage("tour");
        BufferedImage image =
                new BufferedImage(view.getPreferredSize().width, view.getPreferredSize().height, BufferedImage.TYPE_INT_RGB);
        view.paintComponent(image.createGraphics());
        if (view.getFrame() != null) {
            throw new IllegalStateException("a window without a display");
        }
        GameView.Images images = view.new Images();
        images.getPacMan(MOVE.LEFT, 0);
        images.getPacManForExtraLives();
        images.getGhost(GHOST.BLINKY, MOVE.LEFT, 0);
        images.getEdibleGhost(true, 0);
        images.getMaze(0);
    }

    /** Opens a window and never ends; compiled and linked, but not run. */
    private static void unending() {
        GameView view = new GameView(new Game(0));
        GameView.GameFrame frame = view.new GameFrame(new JPanel());
        frame.dispose();
        Executor.main(new String[0]);
    }

    private static void files() {
        new File(IO.DIRECTORY).mkdir();
        new IO();
        if (!IO.saveFile("tour.txt", "a line", false) || !IO.loadFile("tour.txt").equals("a line\n")) {
            throw new IllegalStateException("a file is not read as it was written");
        }
        Log log = Log.getLog();
        log.enableConsolePrinting();
        log.enableTimeStamp();
        log.log(log, "on the console");
        log.disableTimeStamp();
        log.disableConsolePrinting();
        log.setFile("tour-log.txt");
        log.saveLog(false);
        log.clear();
    }

    private static void executor() {
        Executor executor = new Executor();
        executor.runExperiment(new StarterPacMan(), new Legacy(), 2);
        executor.runExperiment(new StarterPacMan(), new Legacy(), new Game(3));
        executor.runGame(new StarterPacMan(), new Legacy(), true, 0);
        // A timed game of many steps takes long: the thread is told to stop before it begins.
        Thread.currentThread().interrupt();
        executor.runGameTimed(new StarterPacMan(), new Legacy(), false);
        executor.runGameTimed(new StarterPacMan(), new Legacy(), false, new Game(1)).gameOver();
        executor.runGameTimedSpeedOptimised(new StarterPacMan(), new Legacy(), false, false);
        executor.runGameTimedSpeedOptimised(new StarterPacMan(), new Legacy(), false, false, new Game(1));
        executor.runGameTimedRecorded(new StarterPacMan(), new Legacy(), false, IO.DIRECTORY + "none.txt");
        executor.runGameTimedRecorded(new Game(1), new StarterPacMan(), new Legacy(), false, IO.DIRECTORY + "none.txt");
        if (!Thread.interrupted()) {
            throw new IllegalStateException("an interrupt is lost");
        }
        Executor.saveToFile(new Game(0).getGameState(), IO.DIRECTORY + "game.txt", false);
        executor.replayGame(IO.DIRECTORY + "game.txt", false);
        executor.replayGame(IO.DIRECTORY + "game.txt", true, 0);
    }

    private static void controllerThreads() throws InterruptedException {
        KeyBoardInput keys = new KeyBoardInput();
        keys.keyPressed(new KeyEvent(new JPanel(), KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_UP, KeyEvent.CHAR_UNDEFINED));
        HumanController human = new HumanController(keys);
        human.input = human.getKeyboardInput();
        if (keys.getKey() != KeyEvent.VK_UP || human.getMove(new Game(0), 0) != MOVE.UP) {
            throw new IllegalStateException("a key is not noticed");
        }
        human.threadRevive();
        Thread thread = new Thread(human);
        thread.start();
        human.update(new Game(0), 0);
        while (!human.hasComputed()) {
            Thread.yield();
        }
        if (human.getMove() != MOVE.UP) {
            throw new IllegalStateException("an answer is not stored");
        }
        human.terminate();
        thread.join();
        human.run();
    }
}
