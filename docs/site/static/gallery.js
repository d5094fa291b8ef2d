// Filters of the gallery's cards: a card stays if it has the chosen words and is below every chosen limit.
document.addEventListener("DOMContentLoaded", () => {
  const form = document.querySelector(".gallery-filters");
  if (!form) return;
  const cards = [...document.querySelectorAll(".gallery-card")];
  const fits = (card, { name, value }) =>
    !value || (isNaN(value) ? card.dataset[name] === value : Number(card.dataset[name]) <= Number(value));
  const filter = () => {
    const chosen = [...form.querySelectorAll("select")];
    for (const card of cards) card.hidden = !chosen.every((select) => fits(card, select));
    form.querySelector("output").textContent = `${cards.filter((card) => !card.hidden).length} of ${cards.length} designs`;
  };
  form.addEventListener("change", filter);
  form.hidden = false;
  filter();
});
