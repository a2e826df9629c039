// A table wider than its region says so while some of it lies to the right, also to those who hear the page.

for (const region of document.querySelectorAll(".wide")) {
  const hint = region.previousElementSibling;
  const caption = document.getElementById(region.getAttribute("aria-labelledby"));
  const name = caption ? caption.textContent : region.getAttribute("aria-label");
  region.removeAttribute("aria-labelledby");

  const look = () => {
    const unseen = region.scrollWidth - region.clientWidth;
    const wider = unseen >= 2; // less is rounding
    hint.hidden = !wider;
    hint.classList.toggle("seen", unseen - region.scrollLeft < 2);
    region.tabIndex = wider ? 0 : -1;
    region.setAttribute("aria-label", wider ? `${name} (${hint.textContent})` : name);
  };
  const watch = new ResizeObserver(look);
  watch.observe(region);
  watch.observe(region.firstElementChild);
  region.addEventListener("scroll", look, { passive: true });
}
