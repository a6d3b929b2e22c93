/** Human-specified divisions of the task among the output modules of a network. */
package mmneat.mspacman.modules;
