/**
 * Loading of controllers by class name: controllers of this program, and competition entries from a jar or class
 * folder.
 */
package mmneat.contest.entry;
