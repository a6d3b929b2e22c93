/**
 * Files of genotypes: our JSON form, the original's XML, and drawings of networks as SVG, DOT and GraphML.
 *
 * <p>The JSON form needs Jackson; the rest needs only the JDK. Nothing else in {@code mmneat.neat} depends on this
 * package.
 *
 * <p>Source: docs/genotype-format.md; docs/specification/networks.md, section 12.
 */
@NullMarked
package mmneat.neat.io;

import org.jspecify.annotations.NullMarked;
