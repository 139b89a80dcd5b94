#lang scribble/manual
@(require (for-label mechanics) "../citation.rkt")

@title[#:tag "reference-base"]{A smaller library}

@defmodule[mechanics/base #:packages ("mechanics")]

The mathematics without the mechanics: what is described under
@secref["reference-arithmetic"], @secref["reference-structures"],
@secref["reference-linear"], @secref["reference-functions"],
@secref["reference-literals"], @secref["reference-derivatives"] without
@racket[delta], @secref["reference-expressions"] without the procedures that
show, and @secref["reference-verdicts"] without @racket[verify-solution]; and the
binding forms with patterns and the loops of @secref["reference-language"].

It provides nothing else: not @racketmodname[racket/base], which a module written
in a language of Racket has anyway.
