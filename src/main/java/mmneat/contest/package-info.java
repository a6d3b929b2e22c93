/** Contests: many games between two controllers, what they score, and what happens when a controller fails. */
package mmneat.contest;
