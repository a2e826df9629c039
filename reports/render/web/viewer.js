// The window in which a figure is enlarged, or its bodies are turned.

const viewer = document.getElementById("viewer");
const stage = viewer.querySelector(".stage");
let moved = null; // what the reader moves now

function present(figure, content, made) {
  stage.replaceChildren(content);
  viewer.querySelector(".caption").replaceChildren(...figure.querySelector("figcaption").cloneNode(true).childNodes);
  viewer.classList.toggle("turning", content instanceof HTMLCanvasElement);
  viewer.showModal();
  stage.focus();
  moved = made;
  moved.reset();
}

function enlarge(figure) {
  const picture = figure.querySelector(".picture svg").cloneNode(true);
  present(figure, picture, zoomable(picture));
}

function turn(figure) {
  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-labelledby", figure.querySelector("figcaption").id);
  const model = JSON.parse(figure.querySelector("script").textContent);
  present(figure, canvas, turnable(canvas, model));
}

listenForGestures(stage, () => moved);
viewer.addEventListener("close", () => {
  moved = null;
  stage.replaceChildren();
});
viewer.addEventListener("click", (event) => {
  const action = event.target.closest("button")?.dataset.action;
  if (action === "close" || event.target === viewer) viewer.close();
  else if (action) KEYS[action](moved, stage);
});
addEventListener("resize", () => moved?.reset());

for (const figure of document.querySelectorAll("main figure:has(.picture)")) {
  const tools = document.getElementById("tools").content.cloneNode(true);
  const [larger, turned] = tools.querySelectorAll("button");
  const caption = figure.querySelector("figcaption");
  for (const button of [larger, turned]) button.setAttribute("aria-describedby", caption.id);
  larger.addEventListener("click", () => enlarge(figure));
  turned.addEventListener("click", () => turn(figure));
  if (!figure.querySelector("script")) turned.remove();
  figure.querySelector(".picture").addEventListener("click", () => enlarge(figure));
  caption.before(tools);
}
