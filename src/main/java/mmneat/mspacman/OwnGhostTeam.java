package mmneat.mspacman;

import java.util.EnumMap;
import java.util.Objects;
import java.util.function.Supplier;
import mmneat.neat.OwnPart;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;
import pacman.controllers.NewGhostController;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A ghost team of the user's own, for example an entry of a contest. A new team is created for each game, so that a
 * game does not depend on earlier games. What a team throws becomes a {@link mmneat.neat.BadPartException}.
 */
public final class OwnGhostTeam extends NewGhostController {

    private static final GHOST[] GHOSTS = GHOST.values();

    private final Supplier<? extends Controller<EnumMap<GHOST, MOVE>>> teams;
    private Controller<EnumMap<GHOST, MOVE>> team;
    private OwnPart part;

    /** @param teams makes the team of a game */
    public OwnGhostTeam(Supplier<? extends Controller<EnumMap<GHOST, MOVE>>> teams) {
        this.teams = Objects.requireNonNull(teams, "teams");
        reset();
    }

    @Override
    public void reset() {
        team = teams.get();
        part = OwnPart.of("ghost team", team);
        if (team instanceof NewGhostController resettable) {
            part.call(() -> {
                resettable.reset();
                return resettable;
            });
        }
    }

    @Override
    public @Nullable EnumMap<GHOST, MOVE> getMove(Game game, long timeDue) {
        return part.call(() -> {
            EnumMap<GHOST, MOVE> moves = team.getMove(game, timeDue);
            if (moves != null) {
                // A map of another type fails here, where the team is named, and not in the game.
                for (GHOST ghost : GHOSTS) {
                    MOVE.class.cast(moves.get(ghost));
                }
            }
            return moves;
        });
    }
}
