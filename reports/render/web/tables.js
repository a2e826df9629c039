// Tables are sorted by a click on the head of a column: rising, falling, as they were.

const ORDERS = ["ascending", "descending", "none"];
const words = new Intl.Collator(document.documentElement.lang, { numeric: true });

for (const table of document.querySelectorAll("table.sortable")) {
  const body = table.tBodies[0];
  const given = [...body.rows];
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const order = ORDERS[(ORDERS.indexOf(head.ariaSort ?? "none") + 1) % ORDERS.length];
      for (const other of heads) other.removeAttribute("aria-sort");
      if (order !== "none") head.setAttribute("aria-sort", order);
      body.append(...sorted(given, column, order));
    });
  });
}

// The rows by the cells of one column, those without a value last.
function sorted(rows, column, order) {
  if (order === "none") return rows;
  const sign = order === "ascending" ? 1 : -1;
  const keys = new Map(rows.map((row) => [row, keyOf(row.cells[column])]));
  return [...rows].sort((one, other) => {
    const [a, b] = [keys.get(one), keys.get(other)];
    if (a.empty || b.empty) return a.empty - b.empty;
    if (a.number !== null && b.number !== null) return sign * (a.number - b.number);
    return sign * ((b.number !== null) - (a.number !== null) || words.compare(a.text, b.text));
  });
}

function keyOf(cell) {
  const number = cell.dataset.value === undefined ? null : Number(cell.dataset.value);
  return { empty: cell.classList.contains("empty"), number, text: cell.textContent };
}
