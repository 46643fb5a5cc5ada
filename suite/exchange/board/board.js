document.querySelectorAll("table.board").forEach(function (table) {
  var heads = Array.from(table.tHead.rows[0].cells), body = table.tBodies[0];
  heads.forEach(function (head, column) {
    head.addEventListener("click", function () {
      var up = head.getAttribute("aria-sort") !== "ascending";
      heads.forEach(function (other) { other.removeAttribute("aria-sort"); });
      head.setAttribute("aria-sort", up ? "ascending" : "descending");
      var key = function (row) { return row.cells[column].dataset.key; };
      var rows = Array.from(body.rows).sort(function (a, b) {
        var x = key(a), y = key(b), numeric = head.classList.contains("number");
        return (numeric ? Number(x) - Number(y) || 0 : x.localeCompare(y)) * (up ? 1 : -1);
      });
      rows.forEach(function (row) { body.appendChild(row); });
    });
  });
  var filter = table.closest("div.wide").previousElementSibling;
  if (filter && filter.matches("input.filter"))
    filter.addEventListener("input", function () {
      var word = filter.value.toLowerCase();
      Array.from(body.rows).forEach(function (row) {
        row.hidden = row.textContent.toLowerCase().indexOf(word) < 0;
      });
    });
});
