"""What a part of the attack has measured, and what did not hold."""


class Outcome:
    """Figures and failures of one part, each a sentence."""

    def __init__(self, part, say=print):
        self.part = part
        self.figures = []
        self.failures = []
        self._say = say

    def figure(self, words):
        """A fact that is neither good nor bad, such as a rate that was reached."""
        self.figures.append(words)
        self._say('%s: %s' % (self.part, words))

    def expect(self, held, words):
        """`words` say what did not hold if `held` is not true. Gives whether it held."""
        if not held:
            self.failures.append(words)
            self._say('%s: FAILED: %s' % (self.part, words))
        return bool(held)
