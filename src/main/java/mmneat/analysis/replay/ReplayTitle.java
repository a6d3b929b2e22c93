package mmneat.analysis.replay;

/**
 * The heading and subtitle of a recorded game.
 *
 * @param heading name of the player, for example "blended 2M, run 7"
 * @param subtitle the rules and the seed that gives the same game again, for example "training rules, seed 1"
 */
public record ReplayTitle(String heading, String subtitle) {}
