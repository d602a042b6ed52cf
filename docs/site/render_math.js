// Draws the formulas, which MkDocs leaves as \( ... \) and \[ ... \], with KaTeX.
document.addEventListener("DOMContentLoaded", function () {
  document.querySelectorAll(".arithmatex").forEach(function (element) {
    const text = element.textContent.trim();
    const formula = text.slice(2, -2);
    katex.render(formula, element, {displayMode: text.startsWith("\\["), throwOnError: false});
  });
});
