package mmneat.analysis.replay;

import mmneat.analysis.Page;

/** The HTML page that shows a {@link Replay}: one file, opened from disk, without the network. */
public final class ReplayPage {

    private ReplayPage() {}

    public static String html(Replay replay) {
        return new Page("replay", "replay.html")
                .withText("heading", replay.title().heading())
                .withText("subtitle", replay.title().subtitle())
                .withJson("replay", replay.json())
                .withJson("moduleColours", ModuleColours.json())
                .html();
    }
}
