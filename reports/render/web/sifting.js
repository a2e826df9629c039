// A long table of outcomes: only the rows of one outcome, and only those with some words.

for (const table of document.querySelectorAll("table.sifted")) {
  const form = document.getElementById("sifting").content.firstElementChild.cloneNode(true);
  const [select, search, count] = ["select", "input", "output"].map((name) => form.querySelector(name));
  const rows = [...table.tBodies[0].rows].map((row) => {
    const outcome = row.querySelector(".pass, .fail, .incomplete, .comparison");
    return { row, outcome: outcome?.textContent ?? "", words: row.textContent.toLowerCase() };
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
  form.addEventListener("input", sift);
  form.addEventListener("submit", (event) => event.preventDefault());
  sift();
  table.closest(".wide").before(form);
}
