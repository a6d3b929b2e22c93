/**
 * What a researcher does once the runs are there: evaluate champions, compare methods, draw figures, write reports and watch
 * games.
 */
package mmneat.analysis;
