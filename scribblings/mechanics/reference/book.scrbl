#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../citation.rkt")

@title[#:tag "reference-book" #:style '(toc)]{The book's objects}

@defmodule[mechanics/book #:packages ("mechanics")]

The particular Lagrangians, paths and other objects that the text of @|the-book| defines,
so that its programs run without being typed in first. They are written in the language
that a reader has, in one file for each section under @filepath{mechanics/book}, and these
files are meant to be read. The module shares no name with @racketmodname[mechanics], which
has all that works on these objects.

Parameters are scalars in any consistent system of units, local tuples are
@racket[(up t q v)]. A definition of one's own replaces what is imported.

@local-table-of-contents[]

@include-section["book/section-1-4.scrbl"]
@include-section["book/section-1-5.scrbl"]
@include-section["book/section-1-6.scrbl"]
@include-section["book/section-1-7.scrbl"]
@include-section["book/section-1-8.scrbl"]
@include-section["book/section-2-8.scrbl"]
@include-section["book/section-3.scrbl"]
@include-section["book/section-3-6.scrbl"]
@include-section["book/section-5.scrbl"]
@include-section["book/editions.scrbl"]
