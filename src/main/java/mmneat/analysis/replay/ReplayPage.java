package mmneat.analysis.replay;

import mmneat.analysis.Page;

/** Writer of the HTML page that shows a {@link Replay}: one file, which a browser opens from disk without Internet. */
public final class ReplayPage {

    private ReplayPage() {}

    /** Returns the complete page. */
    public static String html(Replay replay) {
        return new Page("replay", "replay.html")
                .withText("heading", replay.title().heading())
                .withText("subtitle", replay.title().subtitle())
                .withJson("replay", replay.json())
                .withJson("moduleColours", ModuleColours.json())
                .html();
    }
}
