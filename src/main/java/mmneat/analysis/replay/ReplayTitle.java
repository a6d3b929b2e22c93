package mmneat.analysis.replay;

/**
 * What the page says about a game.
 *
 * @param heading who plays, for example "blended 2M, run 7"
 * @param subtitle the rules and how to get the same game again, for example "training rules, seed 1"
 */
public record ReplayTitle(String heading, String subtitle) {}
