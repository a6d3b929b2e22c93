/** What a game is scored on: the objectives of evolution and the other scores that are recorded. */
package mmneat.mspacman.objectives;
