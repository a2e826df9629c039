// The contents are open beside the report where there is room, and folded within it where there is none.

const contents = document.querySelector("nav details");
const roomy = matchMedia("(min-width: 72rem)"); // as in report.css

function fold() {
  contents.open = roomy.matches;
}

fold();
roomy.addEventListener("change", fold);
contents.addEventListener("click", (event) => {
  if (event.target.closest("a") && !roomy.matches) contents.open = false;
});
