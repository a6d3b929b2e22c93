package mmneat.random;

import java.util.Random;

/**
 * The number sequence of {@link java.util.Random}, with a state that can be read and set.
 *
 * <p>Every draw returns the same number as {@code java.util.Random} with the same seed, including the second value of a
 * pair of Gaussians. Drawing uses no locks and no atomic operations, so a generator is used by one thread only. The
 * class extends {@code java.util.Random} because controllers of the competition use {@code Game.rnd} as one.
 *
 * <p>Source: docs/specification/networks.md, section 2; the documented algorithm of {@code java.util.Random}.
 */
public final class ResumableRandom extends Random {

    private static final long serialVersionUID = 1;

    private static final long MULTIPLIER = 0x5DEECE66DL;
    private static final long ADDEND = 0xBL;
    private static final long MASK = (1L << 48) - 1;
    private static final double DOUBLE_UNIT = 0x1.0p-53;
    private static final float FLOAT_UNIT = 0x1.0p-24f;

    /** The 48 bits of the linear congruential generator, already scrambled. */
    private long bits;

    private double cachedGaussian;
    private boolean hasCachedGaussian;

    /** A generator that continues as {@code new java.util.Random(seed)} would. */
    public ResumableRandom(long seed) {
        super(seed); // which calls setSeed
    }

    private ResumableRandom(ResumableRandom other) {
        super(0);
        continueAs(other);
    }

    /** A generator that continues from {@code state}. */
    public static ResumableRandom resume(State state) {
        ResumableRandom random = new ResumableRandom(0);
        random.setState(state);
        return random;
    }

    /** Starts the sequence of {@code new java.util.Random(seed)}; a cached Gaussian is dropped. */
    @Override
    public void setSeed(long seed) {
        bits = (seed ^ MULTIPLIER) & MASK;
        hasCachedGaussian = false;
    }

    /** An independent generator that continues exactly as this one would. */
    public ResumableRandom copy() {
        return new ResumableRandom(this);
    }

    /** Makes this generator continue as {@code other} would, without allocation. */
    public void continueAs(ResumableRandom other) {
        bits = other.bits;
        cachedGaussian = other.cachedGaussian;
        hasCachedGaussian = other.hasCachedGaussian;
    }

    /** Returns the complete state, which determines all later numbers. */
    public State state() {
        return new State(bits, hasCachedGaussian, hasCachedGaussian ? cachedGaussian : 0);
    }

    /** Makes this generator continue from {@code state}. */
    public void setState(State state) {
        bits = state.bits();
        hasCachedGaussian = state.hasCachedGaussian();
        cachedGaussian = state.cachedGaussian();
    }

    /**
     * The 48 bits of the linear congruential generator, the same number as {@link State#bits}. {@code java.util.Random}
     * keeps the same bits: they are the seed exclusive-or 0x5DEECE66D before the first draw.
     */
    public long bits() {
        return bits;
    }

    @Override
    protected int next(int count) {
        bits = (bits * MULTIPLIER + ADDEND) & MASK;
        return (int) (bits >>> (48 - count));
    }

    @Override
    public int nextInt() {
        return next(32);
    }

    /**
     * {@inheritDoc} Uniform over [0, bound).
     *
     * @throws IllegalArgumentException if the bound is not positive
     */
    @Override
    public int nextInt(int bound) {
        if (bound <= 0) {
            throw new IllegalArgumentException("bound must be positive, is " + bound);
        }
        int draw = next(31);
        int mask = bound - 1;
        if ((bound & mask) == 0) {
            return (int) ((bound * (long) draw) >> 31);
        }
        // Rejects the incomplete last stretch of numbers, so that every value is equally likely.
        int value = draw % bound;
        while (draw - value + mask < 0) {
            draw = next(31);
            value = draw % bound;
        }
        return value;
    }

    /** {@inheritDoc} Four bytes of each number, the lowest first. */
    @Override
    public void nextBytes(byte[] bytes) {
        int number = 0;
        for (int i = 0; i < bytes.length; i++) {
            number = i % Integer.BYTES == 0 ? nextInt() : number >> Byte.SIZE;
            bytes[i] = (byte) number;
        }
    }

    @Override
    public long nextLong() {
        return ((long) next(32) << 32) + next(32);
    }

    @Override
    public boolean nextBoolean() {
        return next(1) != 0;
    }

    @Override
    public float nextFloat() {
        return next(24) * FLOAT_UNIT;
    }

    @Override
    public double nextDouble() {
        return (((long) next(26) << 27) + next(27)) * DOUBLE_UNIT;
    }

    /** {@inheritDoc} Marsaglia's polar method, which makes two values at a time and keeps the second. */
    @Override
    public double nextGaussian() {
        if (hasCachedGaussian) {
            hasCachedGaussian = false;
            return cachedGaussian;
        }
        double first;
        double second;
        double square;
        do {
            first = 2 * nextDouble() - 1;
            second = 2 * nextDouble() - 1;
            square = first * first + second * second;
        } while (square >= 1 || square == 0);
        double scale = StrictMath.sqrt(-2 * StrictMath.log(square) / square);
        cachedGaussian = second * scale;
        hasCachedGaussian = true;
        return first * scale;
    }

    /**
     * State of a generator between two draws.
     *
     * @param bits the 48 bits of the linear congruential generator, in [0, 2^48)
     * @param hasCachedGaussian whether the next Gaussian is already known
     * @param cachedGaussian that Gaussian; 0 if there is none
     */
    public record State(long bits, boolean hasCachedGaussian, double cachedGaussian) {
        /**
         * A checked state.
         *
         * @throws IllegalArgumentException if the bits are not 48, or the Gaussian is not finite
         */
        public State {
            if (bits < 0 || bits > MASK) {
                throw new IllegalArgumentException("generator state must be in [0, 2^48), is " + bits);
            }
            if (!Double.isFinite(cachedGaussian)) {
                throw new IllegalArgumentException("cached Gaussian must be finite, is " + cachedGaussian);
            }
        }
    }
}
