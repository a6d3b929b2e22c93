package pacman.game;

/** Seeds of the generators of independent copies of a game ({@link GameRules.Copies#ARE_INDEPENDENT}). */
final class CopySeeds {

    /** An odd number near 2^64 divided by the golden ratio: it spreads a counter over all numbers. */
    private static final long INCREMENT = 0x9E3779B97F4A7C15L;

    private CopySeeds() {}

    /**
     * The finaliser of SplitMix64 (Steele, Lea and Flood 2014, doi:10.1145/2660193.2660195) over a counter. It mixes
     * all bits, so that neighbouring copies are unrelated. A generator keeps 48 of the 64 bits, so the seed cannot be
     * recovered from it.
     *
     * @param seed seed of the game or copy that is being copied
     * @param time game time in steps
     * @param number of the copy, from 1
     */
    static long of(long seed, int time, int number) {
        long mixed = seed + INCREMENT * (((long) time << Integer.SIZE) + number);
        mixed = (mixed ^ mixed >>> 30) * 0xBF58476D1CE4E5B9L;
        mixed = (mixed ^ mixed >>> 27) * 0x94D049BB133111EBL;
        return mixed ^ mixed >>> 31;
    }
}
