// A long table of outcomes: only the rows of one outcome, and only those with some words.

const MOST = 1000; // rows that the style sheet shows at once

for (const table of document.querySelectorAll("table.sifted")) {
  const form = document.getElementById("sifting").content.firstElementChild.cloneNode(true);
  const [select, search, whole, count] = ["select", "[type=search]", "[type=checkbox]", "output"].map((name) => form.querySelector(name));
  const rows = [...table.tBodies[0].rows].map((row) => {
    const outcome = row.querySelector(".pass, .fail, .incomplete, .comparison");
    return { row, outcome: outcome?.textContent ?? "", words: [...row.cells].map((cell) => cell.textContent.toLowerCase()).join("\n") };
  });
  const numbers = new Map();
  for (const { outcome } of rows) numbers.set(outcome, (numbers.get(outcome) ?? 0) + 1);
  for (const [outcome, number] of numbers) select.append(new Option(`${outcome} (${number})`, outcome));

  const sift = () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const each of rows) {
      const fits = (!select.value || each.outcome === select.value) && words.every((word) => each.words.includes(word));
      each.row.hidden = !fits;
      shown += fits;
    }
    count.textContent = `${shown} / ${rows.length}`;
  };
  whole.addEventListener("change", () => table.classList.toggle("whole", whole.checked));
  whole.parentElement.hidden = rows.length <= MOST;
  for (const event of ["input", "change"]) form.addEventListener(event, sift);
  form.addEventListener("submit", (event) => event.preventDefault());
  sift();
  table.closest(".wide").before(form);
}
