/** Errors in what the user asked for, and the words in which they are reported. */
package mmneat.experiment;
