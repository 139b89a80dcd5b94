#lang racket/base
;; Formulas in Racket's editors: a snip that draws them, in the color and with the size of the
;; letters around it.
;;
;; DrRacket does not let a program's snips into its own windows: it has them written, and reads
;; them with the class that it finds by the name, in an instance of this file of its own.  So
;; little is loaded here before something is drawn, nothing of the program is needed to read,
;; draw or copy a formula, and a file with one in it can be opened again.
;;
;; Where the text of an editor is taken, copied elsewhere, or read as a program, a formula is
;; the S-expression of its value.

(require "result-formula.rkt"
         "../../generic/on-demand.rkt"
         file/convertible
         racket/class racket/snip)

(require-on-demand ["formula-drawing.rkt" convert-formula make-drawing drawing-width
                                          drawing-height drawing-descent draw-drawing]
                   ["formula-menu.rkt" formula-menu])

(provide formula->snip formula-snip% snip-class)

(define (formula->snip f) (new formula-snip% [formula f]))

;; ---------------------------------------------------------------------------
;; Drawn in the color and size of the letters of the style

(define drawn-formula%
  (class snip%
    (init-field formula)
    (inherit get-style)
    (super-new)

    (define drawing #f)               ; as it was drawn last
    (define drawn-size #f)

    (define/private (present-drawing)
      (define size (send (send (get-style) get-font) get-size))
      (unless (equal? size drawn-size)
        (set! drawing (make-drawing formula size))
        (set! drawn-size size))
      drawing)

    (define/override (get-extent dc x y . boxes)
      (give-extent (present-drawing) boxes))
    (define/override (draw dc x y left top right bottom dx dy caret)
      (draw-drawing (present-drawing) dc x y (send (get-style) get-foreground)))

    ;; A tall one is scrolled through.
    (define/override (get-num-scroll-steps)
      (max 1 (steps (drawing-height (present-drawing)))))
    (define/override (find-scroll-step y) (max 0 (steps y)))
    (define/override (get-scroll-step-offset n) (* n step))))

(define step 16)
(define (steps y) (quotient (inexact->exact (ceiling y)) step))

;; boxes : up to six, for width, height, descent and the spaces above, left and right; #f for one
;; that is not wanted
(define (give-extent d boxes)
  (define extent (list (drawing-width d) (drawing-height d) (drawing-descent d) 0 0 0))
  (for ([b (in-list boxes)] [value (in-list extent)])
    (when b (set-box! b value))))

;; ---------------------------------------------------------------------------
;; Copied, read, converted

(define convertible<%>
  (interface* () ([prop:convertible (lambda (s request default)
                                      (send s convert-to request default))])))

(define formula-snip%
  (class* drawn-formula% (readable-snip<%> convertible<%>)
    (inherit-field formula)
    (inherit get-admin get-flags set-flags set-snipclass)
    (super-new)
    (set-snipclass snip-class)
    (set-flags (cons 'handles-events (get-flags)))

    (define/override (copy) (new formula-snip% [formula formula]))
    (define/override (write stream) (send stream put (formula->bytes formula)))
    (define/override (get-text offset count [flattened? #f])
      (if flattened? (formula-program formula) (super get-text offset count flattened?)))
    (define/public (read-special source line column position)
      (formula-syntax formula (list source line column position 1)))
    (define/public (convert-to request default) (convert-formula formula request default))

    ;; The right button of the mouse is for our menu, all else for the editor.
    (define/override (on-event dc x y editor-x editor-y event)
      (define admin (get-admin))
      (when admin
        (define editor (send admin get-editor))
        (send editor set-caret-owner #f)
        (if (send event button-down? 'right)
            (send admin popup-menu (formula-menu formula) this
                  (- (send event get-x) x) (- (send event get-y) y))
            (send editor on-local-event event))))))

;; ---------------------------------------------------------------------------
;; In files

(define snip-class
  (new (class snip-class%
         (define/override (read stream)
           (define f (bytes->formula (send stream get-unterminated-bytes)))
           (and f (formula->snip f)))
         (super-new))))

;; Where this class is, and the reader for those who have no editors.
(send snip-class set-classname
      (format "~s" '((lib "formula-snip.rkt" "mechanics" "show" "display")
                     (lib "formula-reader.rkt" "mechanics" "show" "display"))))
(send snip-class set-version 1)
(send (get-the-snip-class-list) add snip-class)
