/** Errors of the user and the texts that report them. */
package mmneat.experiment;
