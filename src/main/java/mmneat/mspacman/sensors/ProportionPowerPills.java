package mmneat.mspacman.sensors;

/** "Proportion Power Pills": power pills left / power pills of the maze, in [0, 1]. */
record ProportionPowerPills() implements Sensor {

    @Override
    public String label() {
        return "Portion Power Pill Remaining";
    }

    @Override
    public boolean isDirectional() {
        return false;
    }

    @Override
    public double sense(Situation situation) {
        return (double) situation.powerPillsLeft() / situation.powerPillsOfMaze();
    }
}
