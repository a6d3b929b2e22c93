/**
 * The output of commands: files, tables, progress on the terminal, and windows.
 *
 * <p>Nothing here knows a command.
 */
@NullMarked
package mmneat.cli.output;

import org.jspecify.annotations.NullMarked;
