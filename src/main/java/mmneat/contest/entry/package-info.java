/** Controllers by class name: ours, and entries of others from a jar or class folder. */
package mmneat.contest.entry;
