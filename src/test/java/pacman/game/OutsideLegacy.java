package pacman.game;

import pacman.controllers.examples.Legacy;

/** A ghost team that extends an example, as an entry may. */
public final class OutsideLegacy extends Legacy {}
