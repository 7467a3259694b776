// What rows and columns are called, in patterns of RE2.
#pragma once

// Those that are called so by themselves, too: "rows".
#define RAYGRADE_ROW "rows?|zeile|reihe|ligne|fila|linha|riga|wiersz|rij"
#define RAYGRADE_COLUMN "spalte|colonne|columna|coluna|colonna|kolumna|kolom"

// Those that need a number: "line 1".
#define RAYGRADE_NUMBERED_ROW RAYGRADE_ROW "|line|rengl(?:ó|o)n|sat(?:ı|i)r|rad|(?:ř|r)(?:á|a)dek|rivi|eq|equation"
#define RAYGRADE_NUMBERED_COLUMN "col|column|" RAYGRADE_COLUMN "|s(?:ü|u)tun|kolumn|kolonne|sloupec"
