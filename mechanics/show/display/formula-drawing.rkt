#lang racket/base
;; Formulas drawn: for snips, and for whatever asks for bytes of a picture.

(require "../typesetting/drawing-state.rkt" "../typesetting/formula-pict.rkt" "result-formula.rkt"
         file/convertible
         (only-in pict inset make-pict-drawer pict-descent pict-height pict-width
                  text vl-append)
         racket/class
         (only-in racket/string string-split))

(provide make-drawing drawing-width drawing-height drawing-descent draw-drawing
         convert-formula)

;; pict : with its measures; draw! : dc x y -> void
(struct drawing (pict draw!) #:authentic)

(define (drawing-width d) (pict-width (drawing-pict d)))
(define (drawing-height d) (pict-height (drawing-pict d)))
(define (drawing-descent d) (pict-descent (drawing-pict d)))

;; letter-size : that of the letters around it
(define (make-drawing f letter-size)
  (define p (inset (formula->pict f (* larger letter-size)) 0 margin))
  (drawing p (make-pict-drawer p)))

;; Letters of formulas are slender, and those of programs large.
(define larger 1.4)
(define margin 2)

;; A formula that cannot be drawn is written; an editor must not fail for it.
(define (formula->pict f size)
  (with-handlers ([exn:fail? (lambda (e) (written (formula-program f) size))])
    (tree->pict (formula-tree f) size #f)))

(define (written program size)
  (define (line s) (text s 'modern (max 1 (inexact->exact (round size)))))
  (apply vl-append (map line (string-split program "\n"))))

;; Draws in a color; pen, brush and letters of the dc are restored.
(define (draw-drawing d dc x y color)
  (call-restoring-state
   dc
   (lambda ()
     (send* dc
       (set-pen color 1 'solid) (set-brush color 'solid)
       (set-text-foreground color) (set-text-mode 'transparent) (set-smoothing 'smoothed))
     ((drawing-draw! d) dc x y))))

;; ---------------------------------------------------------------------------

;; The size of letters in a picture that stands alone.
(define page-size 16)

;; request : as `convert` names it, 'png-bytes and so on
(define (convert-formula f request default)
  (if (eq? request 'text)
      (formula-text f)
      (convert (formula->pict f page-size) request default)))
