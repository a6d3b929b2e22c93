package pacman.controllers;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;

/** Remembers the most recent key press; releases are ignored, so that a direction sticks. */
public class KeyBoardInput extends KeyAdapter {

    /** Written by the event thread, read by a controller's. */
    private volatile int key;

    /** The key code of the most recent key press, 0 before the first. */
    public int getKey() {
        return key;
    }

    @Override
    public void keyPressed(KeyEvent event) {
        key = event.getKeyCode();
    }
}
