package pacman.controllers;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;

/** The most recent key press. Releases are ignored, so that a direction persists. */
public class KeyBoardInput extends KeyAdapter {

    /** Written by the event thread, read by a controller's thread. */
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
