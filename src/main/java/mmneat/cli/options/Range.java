package mmneat.cli.options;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** The smallest and the largest value that an option with a whole number accepts; see {@link OptionValues}. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.FIELD)
public @interface Range {

    long min();

    /** {@code Integer.MAX_VALUE} or {@code Long.MAX_VALUE} means no upper bound. */
    long max() default Integer.MAX_VALUE;
}
