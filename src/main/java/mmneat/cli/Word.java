package mmneat.cli;

/**
 * A {@code name=value} word that a command understands, as its help shows it.
 *
 * @param name what stands before the sign
 * @param value what stands behind it in the help: an example, the choices, or a placeholder in capitals
 * @param meaning what it does, its range and its default
 */
record Word(String name, String value, String meaning) {}
