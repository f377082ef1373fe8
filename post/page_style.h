/* page_style.h - how a page looks: on a screen of any width, light or dark, and printed. */
#ifndef HS_PAGE_STYLE_H
#define HS_PAGE_STYLE_H

extern const char page_style[];

#endif
