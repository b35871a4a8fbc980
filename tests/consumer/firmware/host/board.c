#include "../board.h"

#include <stdio.h>

void write_text(const char* text) { fputs(text, stdout); }
