package mmneat.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TerminalTest {

    @Test
    void dumbTerminal_getsNoEscapes() {
        assertThat(Terminal.understandsEscapes("xterm-256color", true)).isTrue();
        assertThat(Terminal.understandsEscapes(null, true)).isTrue();
        assertThat(Terminal.understandsEscapes("dumb", true)).isFalse();
        assertThat(Terminal.understandsEscapes("xterm-256color", false)).isFalse();
    }
}
