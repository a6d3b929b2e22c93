package mmneat.analysis.tasks;

/** How tasks of one domain are related to each other in time (section 3 of the paper). */
public enum TaskKind {
    /** Only one task is to be done in a game: it never changes. */
    ISOLATED,
    /** The task changes within a game, but seldom, and there is only one at a time. */
    INTERLEAVED,
    /** Several tasks are to be done at the same time, or the task changes so often that they cannot be told apart. */
    BLENDED
}
