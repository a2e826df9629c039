// One pointer drags, two pinch, the wheel zooms, the keyboard does both.
//
// What is listened for moves by `drag(right, down, sideways)` and `zoom(factor, x, y)`, in CSS pixels of the window,
// and returns to where it began by `reset()`. `target()` is what moves now, or null.

const STEP = 40; // of an arrow key [px]
const NEARER = 1.25; // of a key or button

function listenForGestures(stage, target) {
  const pointers = new Map();

  stage.addEventListener("pointerdown", (event) => {
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  });
  stage.addEventListener("pointermove", (event) => {
    if (!pointers.has(event.pointerId) || !target()) return;
    const before = spread(pointers);
    pointers.set(event.pointerId, event);
    const after = spread(pointers);
    target().drag(after.x - before.x, after.y - before.y, event.shiftKey || pointers.size > 1);
    if (before.size && after.size) target().zoom(after.size / before.size, after.x, after.y);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    stage.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  stage.addEventListener("dblclick", () => target()?.reset());
  stage.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY / 40 : event.deltaY;
    target()?.zoom(NEARER ** (-0.4 * Math.max(-5, Math.min(5, lines))), event.clientX, event.clientY);
  }, { passive: false });
  stage.addEventListener("keydown", (event) => {
    const act = KEYS[event.key];
    if (!act || !target() || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act(target(), stage, event.shiftKey);
  });
}

const KEYS = {
  ArrowLeft: (moved, _, sideways) => moved.drag(-STEP, 0, sideways),
  ArrowRight: (moved, _, sideways) => moved.drag(STEP, 0, sideways),
  ArrowUp: (moved, _, sideways) => moved.drag(0, -STEP, sideways),
  ArrowDown: (moved, _, sideways) => moved.drag(0, STEP, sideways),
  "+": (moved, stage) => moved.zoom(NEARER, ...middle(stage)),
  "=": (moved, stage) => moved.zoom(NEARER, ...middle(stage)),
  "-": (moved, stage) => moved.zoom(1 / NEARER, ...middle(stage)),
  0: (moved) => moved.reset(),
};

// The middle of all pointers, and how far two of them are apart (0 for another number).
function spread(pointers) {
  const all = [...pointers.values()];
  const mean = (of) => all.reduce((sum, pointer) => sum + of(pointer), 0) / all.length;
  const [one, other] = all;
  const size = all.length === 2 ? Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY) : 0;
  return { x: mean((pointer) => pointer.clientX), y: mean((pointer) => pointer.clientY), size };
}

function middle(element) {
  const box = element.getBoundingClientRect();
  return [box.left + box.width / 2, box.top + box.height / 2];
}
