package mmneat.mspacman.sensors;

/** "Proportion Pills": pills left / pills of the maze, in [0, 1], even where the game starts with fewer. */
record ProportionPills() implements Sensor {

    @Override
    public String label() {
        return "Portion Pill Remaining";
    }

    @Override
    public boolean isDirectional() {
        return false;
    }

    @Override
    public double sense(Observation observation) {
        return (double) observation.pillsLeft() / observation.pillsOfMaze();
    }
}
