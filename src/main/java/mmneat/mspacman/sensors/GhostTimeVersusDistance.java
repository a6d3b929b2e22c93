package mmneat.mspacman.sensors;

/**
 * Edible time of the nth nearest ghost against its distance: (edible time - steps) / longest edible time, in [-1, 1]; 0 if the
 * ghost is not edible or there is no such ghost. Not part of the published experiments, whose program does not document its
 * own formula.
 *
 * @param n rank of the ghost among those outside the lair by distance in this direction, from 0
 * @param longest edible time of the first level
 */
record GhostTimeVersusDistance(int n, int longest) implements Sensor {

    @Override
    public String label() {
        return n + " Closest Ghost Edible Time vs Distance";
    }

    @Override
    public double sense(Observation observation) {
        int ghost = observation.nthNearestGhost(n);
        if (ghost < 0 || !observation.isEdible(ghost)) {
            return 0;
        }
        double spare = observation.edibleTime(ghost) - observation.distanceToGhost(ghost);
        return Math.max(-1, Math.min(1, spare / longest));
    }
}
