#lang racket/base
;; Blocks of text: lines of one width, of which one is the base line.
;;
;; Put beside one another, blocks have their base lines level.

(require (only-in racket/list make-list)
         (only-in racket/string string-join))

(provide (struct-out box2) text-box box-height box-text
         beside stack raise-box
         fence with-roof columns-wide)

;; lines : strings of `width` columns; base : index of the base line
(struct box2 (lines width base) #:transparent)

(define (box-height b) (length (box2-lines b)))
(define (below-base b) (- (box-height b) (box2-base b) 1))

(define (text-box text) (box2 (list text) (columns-wide text) 0))

;; Characters that are put over others take no column.
(define (columns-wide text)
  (for/sum ([c (in-string text)]) (if (memq (char-general-category c) '(mn me)) 0 1)))

;; The text of a box, without blanks at the ends of lines.
(define (box-text b)
  (string-join (for/list ([l (in-list (box2-lines b))]) (regexp-replace #rx" +$" l "")) "\n"))

(define (blank n) (make-string n #\space))

;; ---------------------------------------------------------------------------
;; Together

(define (beside . boxes)
  (define above (apply max 0 (map box2-base boxes)))
  (define below (apply max 0 (map below-base boxes)))
  (define padded
    (for/list ([b (in-list boxes)])
      (append (make-list (- above (box2-base b)) (blank (box2-width b)))
              (box2-lines b)
              (make-list (- below (below-base b)) (blank (box2-width b))))))
  (box2 (if (null? padded) (list "") (apply map string-append padded))
        (apply + (map box2-width boxes))
        above))

;; One below the other; base : index of the base line of the whole.
;; aligned : 'left or 'center
(define (stack boxes aligned [base #f])
  (define width (apply max 0 (map box2-width boxes)))
  (define lines
    (for*/list ([b (in-list boxes)] [l (in-list (box2-lines b))])
      (define free (- width (box2-width b)))
      (define left (if (eq? aligned 'center) (quotient free 2) 0))
      (string-append (blank left) l (blank (- free left)))))
  (define middle (quotient (max 0 (sub1 (length lines))) 2))
  (box2 (if (null? lines) (list "") lines) width (or base middle)))

;; Raises the box, so that its last line is n lines above the base line.
(define (raise-box b n)
  (define lines (append (box2-lines b) (make-list n (blank (box2-width b)))))
  (box2 lines (box2-width b) (sub1 (length lines))))

;; ---------------------------------------------------------------------------
;; Signs as tall as the box that they enclose

(define (fence b open close) (beside (tall open b) b (tall close b)))

(define (tall sign b)
  (define parts (hash-ref pieces sign))
  (define n (box-height b))
  (define-values (top middle bottom) (apply values parts))
  (box2 (cond [(= n 1) (list sign)]
              [else (append (list top) (make-list (- n 2) middle) (list bottom))])
        1
        (box2-base b)))

(define pieces
  (hash "(" '("⎛" "⎜" "⎝") ")" '("⎞" "⎟" "⎠")
        "[" '("⎡" "⎢" "⎣") "]" '("⎤" "⎥" "⎦")
        "|" '("│" "│" "│")))

;; Under a square root
(define (with-roof b)
  (define n (box-height b))
  (define hook (append (make-list (sub1 n) "│") (list "√")))
  (box2 (cons (string-append " " (make-string (box2-width b) #\_))
              (map string-append hook (box2-lines b)))
        (add1 (box2-width b))
        (add1 (box2-base b))))
