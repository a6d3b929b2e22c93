/**
 * Options and arguments that several commands share: picocli mixins, and the checks of values.
 *
 * <p>A command includes a mixin as a field; the mixin reads the words of the command line and answers the command's
 * question, for example which rules to play by. A wrong value is a {@link mmneat.experiment.UserError}.
 */
@NullMarked
package mmneat.cli.options;

import org.jspecify.annotations.NullMarked;
