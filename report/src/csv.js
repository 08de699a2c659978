// Tables as CSV: all digits, CRLF, no cell that a spreadsheet would take for a formula.

/** A cell. Texts that a spreadsheet would take for a formula get an apostrophe in front. */
function csvCell(value, single = false) {
  if (value === null || value === undefined) return "";
  if (typeof value === "number") return String(single ? Number(value.toPrecision(7)) : value);
  const text = /^[=+\-@\t\r]/.test(value) ? `'${value}` : String(value);
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Rows of a table's columns. */
export function csvOf(columns, rows) {
  const lines = [columns.map((column) => csvCell(column.name)).join(",")];
  for (const row of rows) lines.push(columns.map((column) => csvCell(column.at(row), column.single)).join(","));
  return `${lines.join("\r\n")}\r\n`;
}

/** Lines of values, the first of them the names. */
export function csvOfLines(lines) {
  return `${lines.map((line) => line.map((value) => csvCell(value)).join(",")).join("\r\n")}\r\n`;
}

/** A file's name of any text. */
export function fileName(text) {
  return text.replace(/[^\w.-]+/g, "_").slice(0, 80);
}
