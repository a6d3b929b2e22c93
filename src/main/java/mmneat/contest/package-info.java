/** Contests: many games between two controllers, their scores, and the handling of controllers that fail. */
package mmneat.contest;
